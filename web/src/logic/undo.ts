// Undo and redo of the model text. Keystrokes in quick succession are one step.

export interface Kept { past: string[]; present: string; future: string[] }

export class UndoStack {
  private past: string[] = [];
  private future: string[] = [];
  private lastOrigin = '';
  private lastTime = -Infinity;

  constructor(private present: string, private readonly pause = 800, private readonly limit = 300) {}

  get text(): string { return this.present; }
  get canUndo(): boolean { return this.past.length > 0; }
  get canRedo(): boolean { return this.future.length > 0; }

  /** Records a new text. `origin` names its source ("yaml", "form"): only typing in the same place is merged. */
  push(text: string, origin: string, time: number): void {
    if (text === this.present) return;
    const merge = origin === 'yaml' && origin === this.lastOrigin && time - this.lastTime < this.pause && this.past.length > 0;
    if (!merge) this.past.push(this.present);
    if (this.past.length > this.limit) this.past.shift();
    this.present = text;
    this.future = [];
    this.lastOrigin = origin;
    this.lastTime = time;
  }

  undo(): string | null {
    const text = this.past.pop();
    if (text === undefined) return null;
    this.future.push(this.present);
    return this.settle(text);
  }

  redo(): string | null {
    const text = this.future.pop();
    if (text === undefined) return null;
    this.past.push(this.present);
    return this.settle(text);
  }

  /** Steps kept over a reload: the most recent ones, limited in total characters. */
  keep(room: number): Kept {
    let left = room - this.present.length;
    const near = (list: string[]): string[] => {
      let from = list.length;
      while (from > 0 && left >= list[from - 1]!.length) left -= list[--from]!.length;
      return list.slice(from);
    };
    const past = near(this.past);
    return { past, present: this.present, future: near(this.future) };
  }

  /** Restores the kept steps, followed by the present text, which may have changed meanwhile. */
  static from(kept: Kept | null, text: string): UndoStack {
    const stack = new UndoStack(kept?.present ?? text);
    if (kept) { stack.past = [...kept.past]; stack.future = [...kept.future]; }
    stack.push(text, 'other', 0);
    return stack;
  }

  private settle(text: string): string {
    this.present = text;
    this.lastOrigin = '';
    return text;
  }
}
