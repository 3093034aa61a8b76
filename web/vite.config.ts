import { defineConfig } from "vite";
import { PROTOCOL } from "./src/core/commands";

/** Lets the server see which protocol the page speaks that was built, without running it. */
const protocolInPage = {
  name: "protocol-in-page",
  transformIndexHtml: () => [{ tag: "meta", attrs: { name: "barchan-protocol", content: String(PROTOCOL) }, injectTo: "head" as const }],
};

export default defineConfig({
  base: "./",
  plugins: [protocolInPage],
  build: { outDir: "../src/barchan/studio/client", emptyOutDir: true, chunkSizeWarningLimit: 1500 },
});
