// The picture next to the table, on demand: it shows the selected case if its keys can be tried out.
import { useEffect } from 'preact/hooks';
import { caseKeys, chosenCase, matrix, pictureShown, triedValues, tryValues } from '../../state/studies';

export function useCasePicture(): void {
  const m = matrix.value, c = m?.cases.find(({ number }) => number === chosenCase.value), shown = pictureShown.value;
  useEffect(() => {
    const set = shown && m && c ? triedValues(caseKeys(m, c)) : null;
    if (set) tryValues(set);
  }, [shown, c?.number]);
}
