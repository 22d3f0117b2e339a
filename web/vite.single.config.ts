// The page with the program within it, as one file: script and styles stand in the document, and tools/portable/single_file.mjs
// adds the WebAssembly module and its worker.
import { defineConfig, type Plugin } from 'vite';

/** Nothing may be sent or loaded: what the page shows and keeps stays in the browser. */
const policy = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; frame-src 'self' blob: data:; connect-src 'none'; base-uri 'none'; form-action 'none'";

function inlineAll(): Plugin {
  return {
    name: 'inline-all',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') return this.error('there is no page');
      let html = String(page.source);
      for (const [name, item] of Object.entries(bundle)) {
        if (name === 'index.html') continue;
        // a replacement as a function: the text may have $& in it
        if (item.type === 'chunk') html = html.replace(new RegExp(`<script[^>]*src="[^"]*${item.fileName}"[^>]*></script>`), '').replace('</body>', () => `<script type="module">${item.code.replace(/__VITE_PRELOAD__/g, 'void 0').replace(/<\/script/gi, '<\\/script')}</script>\n</body>`);
        else if (name.endsWith('.css')) html = html.replace(new RegExp(`<link[^>]*href="[^"]*${item.fileName}"[^>]*>`), () => `<style>${String(item.source)}</style>`);
        delete bundle[name];
      }
      page.source = html.replace('<head>', `<head>\n    <meta http-equiv="Content-Security-Policy" content="${policy}">`);
    },
  };
}

export default defineConfig({
  define: { __OVERBEND_ENGINE__: true },
  base: './',
  plugins: [inlineAll()],
  build: {
    target: 'es2022',
    outDir: 'dist-single',
    assetsInlineLimit: 100_000_000,
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: { output: { inlineDynamicImports: true } },
  },
});
