// Connection to the program: monitored by its event stream and by the answers to requests.
import { computed, effect, signal, untracked } from '@preact/signals';
import { transport, watchAnswers } from '../api/client';
import type { Run } from '../api/types';
import { modelEvent, sendAgain } from './model';
import { sayError } from './notices';
import { stageEvent, type StageEvent } from './operation';
import { fetchRuns, runEvent } from './runs';

const streaming = signal(true);
const answering = signal(true);
export const connected = computed(() => streaming.value && answering.value);

/** After an interruption the state is requested again, and unsent text is sent. */
function comeBack(): void {
  void fetchRuns();
  sendAgain();
}

export function connect(): void {
  const on = {
    run: (run: Run) => runEvent(run),
    model: (event: { revision: number }) => modelEvent(event),
    stage: (event: StageEvent) => stageEvent(event),
    unsaved: (event: { message: string }) => sayError(new Error(`This browser does not keep the files of this page: ${event.message}. Download what must last.`)),
  };
  transport.listen(on, (open) => { streaming.value = open; });
  watchAnswers((answered) => { answering.value = answered; });
  let away = false;
  effect(() => {
    const back = connected.value && away;
    away = !connected.value;
    if (back) untracked(comeBack);
  });
}
