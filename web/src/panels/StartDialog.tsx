// The start dialog: a few inputs, all with a default, make a model.
import { useEffect, useState } from 'preact/hooks';
import { ApiError, get, post } from '../api/client';
import type { NewOffer } from '../api/types';
import { check, completed, type Answers, type AnswerErrors } from '../logic/start';
import { tidy, twin } from '../logic/units';
import { openNew } from '../state/model';
import { dialog } from '../state/look';
import { sayError } from '../state/notices';
import { Dialog } from './Dialog';

const text = (v: unknown, unit = '', factor = 1): string => (v === undefined || v === null ? '' : typeof v === 'number' ? `${tidy(v * factor, 5)}${unit ? ` ${unit}` : ''}` : String(v));

function first(o: NewOffer): Answers {
  const d = o.defaults;
  const pipe = text(d.pipe) || (o.pipes.find((p) => p.name.startsWith('16')) ?? o.pipes[0])?.name || '';
  return {
    title: text(d.title), pipe, wall: text(d.wall, 'mm', 1e3), yield: text(d.yield, 'MPa', 1e-6), coating: text(d.coating, 'mm', 1e3), concrete: text(d.concrete, 'mm', 1e3),
    depth: text(d.depth, 'm') || '90 m', vessel: text(d.vessel) || o.vessels[0]?.name || '', lay: d.lay === 'j' ? 'j' : 's',
    stinger_radius: text(d.stinger_radius, 'm'), boxes: text(d.boxes), tension: text(d.tension, 'kN', 1e-3),
  };
}

export function StartDialog() {
  const [offer, setOffer] = useState<NewOffer | null>(null);
  const [a, setA] = useState<Answers | null>(null);
  const [rejected, setRejected] = useState<AnswerErrors & { all?: string }>({});
  const [busy, setBusy] = useState(false);
  // previous text with its unit: a number typed over it keeps that unit
  const [last, setLast] = useState<Partial<Answers>>({});
  const close = (): void => { dialog.value = null; };
  useEffect(() => { get<NewOffer>('new').then((o) => { setOffer(o); const d = first(o); setA(d); setLast(d); }).catch((e: unknown) => { sayError(e); close(); }); }, []);
  if (!offer || !a) return <Dialog key="loading" title="New model" close={close} wide><p class="empty">Loading…</p></Dialog>;

  const pipe = offer.pipes.find((p) => p.name === a.pipe);
  const errors: AnswerErrors = { ...rejected, ...check(a, pipe?.outside_diameter ?? null) };
  const set = (key: keyof Answers, value: string): void => { setRejected({}); setA({ ...a, [key]: value } as Answers); };

  const send = async (): Promise<void> => {
    if (Object.keys(check(a, pipe?.outside_diameter ?? null)).length) return;
    setBusy(true);
    try {
      const given = Object.fromEntries(Object.entries(a).filter(([, v]) => v.trim() !== '').map(([k, v]) => [k, completed(k as keyof Answers, v, last[k as keyof Answers])]));
      if (a.lay === 'j') { delete given.stinger_radius; delete given.boxes; }
      const answer = await post<{ text: string }>('new', { ...given, ...(given.boxes ? { boxes: Number(given.boxes) } : {}) });
      await openNew(answer.text);
      close();
    } catch (error) {
      const key = error instanceof ApiError ? (error.body as { error?: { key?: string } } | null)?.error?.key : undefined;
      if (key && error instanceof ApiError) setRejected({ [key]: error.message });
      else if (error instanceof ApiError && error.status === 422) setRejected({ all: error.message });
      else sayError(error);
    } finally { setBusy(false); }
  };

  const field = (key: keyof Answers, name: string, place: string, list?: string[]) => (
    <div class={`row${errors[key] ? ' wrong' : ''}`}>
      <label for={`n-${key}`}>{name}</label>
      <input id={`n-${key}`} value={a[key]} placeholder={place} list={list ? `l-${key}` : undefined} autocomplete="off" aria-invalid={!!errors[key]} onInput={(e) => set(key, e.currentTarget.value)} onBlur={() => { if (a[key].trim()) { const full = completed(key, a[key], last[key]); setA({ ...a, [key]: full } as Answers); setLast({ ...last, [key]: full }); } }} />
      {list ? <datalist id={`l-${key}`}>{list.map((v) => <option key={v} value={v} />)}</datalist> : null}
      <span class="twin">{twin(completed(key, a[key], last[key]))}</span>
      {errors[key] ? <p class="failuretext" role="alert">{errors[key]}</p> : null}
    </div>
  );
  const vessel = offer.vessels.find((v) => v.name === a.vessel);
  return (
    <Dialog key="asking" title="New model" close={close} wide>
      <form class="start" onSubmit={(e) => { e.preventDefault(); void send(); }}>
        <fieldset>
          <legend>Pipe</legend>
          <div class="row">
            <label for="n-pipe">size (API 5L)</label>
            <select id="n-pipe" autofocus value={a.pipe} onChange={(e) => { setRejected({}); setA({ ...a, pipe: e.currentTarget.value, wall: '' }); }}>
              {offer.pipes.map((p) => <option key={p.name} value={p.name}>{/^[\d.]+$/.test(p.name) ? `${p.name} in` : p.name}</option>)}
            </select>
            <span class="twin">{pipe ? `${tidy(pipe.outside_diameter * 1e3)} mm` : ''}</span>
          </div>
          {field('wall', 'wall thickness', 'automatic', pipe?.walls.map((w) => `${tidy(w * 1e3)} mm`))}
          {field('yield', 'yield stress', 'e.g. 414 MPa', offer.grades.map((g) => `${tidy(g.yield / 1e6)} MPa`))}
          {field('coating', 'corrosion coating', 'none')}
          {field('concrete', 'concrete', 'none')}
        </fieldset>
        <fieldset>
          <legend>Lay</legend>
          {field('depth', 'water depth', 'e.g. 90 m')}
          <div class="row">
            <label for="n-vessel">vessel</label>
            <select id="n-vessel" value={a.vessel} onChange={(e) => set('vessel', e.currentTarget.value)}>{offer.vessels.map((v) => <option key={v.name} value={v.name}>{v.title || v.name}</option>)}</select>
            <span class="twin">{vessel ? `${tidy(vessel.length, 4)} m` : ''}</span>
          </div>
          <div class="row">
            <label for="n-lay">method</label>
            <select id="n-lay" value={a.lay} onChange={(e) => set('lay', e.currentTarget.value)}><option value="s">S-lay, over a stinger</option><option value="j">J-lay, from a tower</option></select>
            <span class="twin" />
          </div>
          {a.lay === 's' ? field('stinger_radius', 'stinger radius', 'automatic') : null}
          {a.lay === 's' ? field('boxes', 'stinger roller boxes', 'automatic') : null}
          {field('tension', 'tension', 'automatic')}
        </fieldset>
        <div class="row title">
          <label for="n-title">title</label>
          <input id="n-title" value={a.title} placeholder="automatic" onInput={(e) => set('title', e.currentTarget.value)} />
        </div>
        {rejected.all ? <p class="failuretext" role="alert">{rejected.all}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || Object.keys(errors).length > 0}>Create</button></footer>
      </form>
    </Dialog>
  );
}
