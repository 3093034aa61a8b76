import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  build: { outDir: "../src/barchan/studio/client", emptyOutDir: true, chunkSizeWarningLimit: 1500 },
});
