import type { Front } from '../components/document';
import { marginStyle } from './margins';

/** A style element that writes title, number and date into the margins of printed pages. */
export function PageMargins({ front }: { front: Front }) {
  return <style>{marginStyle(front)}</style>;
}
