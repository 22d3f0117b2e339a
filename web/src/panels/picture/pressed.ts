// A press on a drawn object selects it; while the ruler is active it sets a ruler point.
import { ruler } from '../../state/picture';

export const pressed = (act: () => void) => (e: PointerEvent): void => { if (!ruler.value) { e.stopPropagation(); act(); } };
