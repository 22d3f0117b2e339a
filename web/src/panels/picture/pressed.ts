// A press on a thing that is drawn selects it; while the ruler is in use it is the ruler's.
import { ruler } from '../../state/picture';

export const pressed = (act: () => void) => (e: PointerEvent): void => { if (!ruler.value) { e.stopPropagation(); act(); } };
