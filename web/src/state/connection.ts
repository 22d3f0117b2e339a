// The stream of events from the program.
import { signal } from '@preact/signals';
import { listen } from '../api/client';
import type { Run } from '../api/types';
import { modelEvent } from './model';
import { stageEvent, type StageEvent } from './operation';
import { fetchRuns, runEvent } from './runs';

export const connected = signal(true);

export function connect(): void {
  let away = false;
  listen({ run: (run: Run) => runEvent(run), model: (event: { revision: number }) => modelEvent(event), stage: (event: StageEvent) => stageEvent(event) }, (on) => {
    connected.value = on;
    // what happened while the program or the network was away is asked for
    if (on && away) void fetchRuns();
    away = !on;
  });
}
