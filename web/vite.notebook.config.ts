import { defineConfig } from "vite";

/** The view for notebooks: one module beside the studio's client, which must have been built before. */
export default defineConfig({
  build: {
    outDir: "../src/barchan/studio/client",
    emptyOutDir: false,
    chunkSizeWarningLimit: 1500,
    lib: { entry: "src/notebook/view.ts", formats: ["es"], fileName: () => "notebook.js" },
  },
});
