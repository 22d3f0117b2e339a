import { defineConfig } from 'vite';

// During development, `OVERBEND_ADDRESS=http://127.0.0.1:PORT npm run dev` forwards /api to a running `overbend serve`.
// The program rejects pages of another origin, so the origin is rewritten.
const program = process.env.OVERBEND_ADDRESS ?? 'http://127.0.0.1:8765';

export default defineConfig({
  define: { __OVERBEND_ENGINE__: false }, // vite.single.config.ts has the program within the page
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 900,
    rollupOptions: {
      output: {
        manualChunks: (id: string) => (/node_modules\/three\//.test(id) ? 'three' : undefined),
        entryFileNames: 'assets/[name]-[hash].js',
      },
    },
  },
  server: {
    host: '127.0.0.1',
    proxy: {
      '/api': {
        target: program,
        changeOrigin: true,
        configure: (proxy) => {
          proxy.on('proxyReq', (request) => request.setHeader('origin', program));
        },
      },
    },
  },
});
