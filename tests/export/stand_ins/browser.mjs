// Stand-ins for what the README's page takes of a browser.
import { readFile } from "node:fs/promises";
let frames = 0, shown = null;
globalThis.fetch = async (name) => { const data = await readFile(name); return { arrayBuffer: async () => data }; };
globalThis.ImageData = class { constructor(data, width, height) { this.data = data; } };
globalThis.document = { querySelector: () => ({ getContext: () => ({ putImageData: (image) => { shown = image.data; } }) }) };
globalThis.requestAnimationFrame = (next) => { if (++frames < 20) next(); };
globalThis.shown = () => shown;
