// Pages that the program makes, shown in a frame.
import { transport } from './client';
import { address } from './http';

/** Contents of a frame: its address, or its text where the program has no addresses. */
export type FrameSource = { src: string } | { srcdoc: string };

export async function frameSource(path: string): Promise<FrameSource> {
  return transport.local ? { srcdoc: await (await transport.file(path)).text() } : { src: address(path) };
}
