import { describe, expect, test } from 'vitest';
import { differences } from '../src/logic/differences';
import { askedOfWaves, motionKind, motionValue } from '../src/logic/motion';
import { bullet, bullets, keyName, withoutPaths, withoutPlace } from '../src/logic/findings';

describe('findings', () => {
  const boxes = ['stinger 1', 'stinger 12', 'ramp 1'];
  test('no path of this machine is shown', () => {
    expect(withoutPaths("'/home/me/models/data/rao.csv': 3 headings")).toBe("'rao.csv': 3 headings");
    expect(withoutPaths('C:\\Users\\me\\a b.csv and /tmp/x/y.yaml:12')).not.toMatch(/Users|tmp/);
    expect(withoutPaths('kN/m^2, 1/2, and/or, m/s')).toBe('kN/m^2, 1/2, and/or, m/s');
    expect(withoutPaths("'/home/me/my models/a b.csv': 3 headings")).toBe("'a b.csv': 3 headings");
    expect(withoutPaths('../data/bgl1/rao.csv')).toBe('../data/bgl1/rao.csv');
  });
  test('the box is named first, not another with the same beginning', () => {
    expect(bullet('the pipe runs off the end of a roller: stinger 12, port roller, by 71 mm', boxes)).toMatchObject({ name: 'stinger 12', full: 'the pipe runs off the end of a roller: port roller, by 71 mm' });
    expect(bullet('nothing of that', boxes).name).toBe('');
  });
  test('a key is named as in the form', () => {
    expect(keyName('supports.stinger.boxes[3].z')).toBe('stinger box 4 z');
    expect(bullet('is unusual', [], 'environment.waves.hs').name).toBe('waves hs');
  });
  test('a long sentence is cut at its first clause and kept as a whole', () => {
    const long = 'the pipe has left the box over the side to port: it lies up to 1.47 m beyond the ends of the bottom rollers, which no longer hold it';
    expect(bullet(long, boxes)).toMatchObject({ short: 'the pipe has left the box over the side to port …', full: long });
  });
  test.each(['30in 300m.yaml:13: warning: ', 'bgl1.yaml:13:5: ', '/home/me/my models/30in 300m.yaml:13: warning: ', 'C:\\Users\\me\\a b.yml:7: warning: ', 'warning: ', ''])('the place in the file in front, "%s", is no part of it', (place) => {
    const said = 'the wall thickness of 7.1 mm is below the smallest of API 5L for 30 in: 7.9 mm are usual for it, and thinner walls are dented by rollers';
    expect(bullet(`${place}${said}`, [])).toMatchObject({ full: said, short: 'the wall thickness of 7.1 mm is below the smallest of API 5L for 30 in …' });
    expect(withoutPlace('rao.yaml is read: 3 columns')).toBe('rao.yaml is read: 3 columns');
  });
  test('a word longer than a bullet is cut', () => expect(bullet('x'.repeat(200), []).short).toBe(`${'x'.repeat(96)} …`));
  test('repeated findings are one bullet, and the serious ones come first', () => {
    const finding = (message: string, severity: 'serious' | 'caution' | 'note') => ({ code: 'free-spans', severity, message });
    const list = bullets([finding('a', 'note'), finding('a', 'note'), finding('b', 'caution'), finding('c', 'serious')], []);
    expect(list.map((b) => `${b.severity} ${b.full}`)).toEqual(['serious c', 'caution b', 'note a']);
  });
});

describe('two texts side by side', () => {
  test('lines that differ, with two lines around', () => {
    const rows = differences('1\n2\n3\n4\n5\n6\n7\n8', '1\n2\n3\n4\n5\nsix\n7\n8\n9');
    expect(rows.filter((r) => r.left !== r.right)).toEqual([{ left: '6', right: 'six' }, { left: null, right: '9' }]);
    expect(rows[0]).toEqual({ left: '4', right: '4' });
  });
  test('equal texts have none', () => expect(differences('a\nb', 'a\nb')).toEqual([]));
  test('an inserted line does not shift the others', () => expect(differences('a\nb\nc', 'a\nx\nb\nc').filter((r) => r.left !== r.right)).toEqual([{ left: null, right: 'x' }]));
});

describe('motion', () => {
  const of = (given: Record<string, unknown>): Map<string, { given: boolean; value: unknown }> => new Map(Object.entries(given).map(([k, value]) => [k, { given: true, value }]));
  test('its kind', () => {
    expect(motionKind(of({}))).toBeNull();
    expect(motionKind(of({ 'vessel.motion': 'fixed' }))).toBe('fixed');
    expect(motionKind(of({ 'vessel.motion': null, 'vessel.motion.raos': 'a.csv' }))).toBe('raos');
  });
  test('another file keeps what is said of its conventions', () => {
    const changed = of({ 'vessel.motion': null, 'vessel.motion.raos': 'a.csv', 'vessel.motion.convention': null, 'vessel.motion.convention.set': 'wamit', 'vessel.motion.convention.reference.x': '2 m' });
    expect(motionValue('raos', 'b.4', changed)).toEqual({ raos: 'b.4', convention: { set: 'wamit', reference: { x: '2 m' } } });
    expect(motionValue('history', 'b.csv', changed)).toEqual({ history: 'b.csv' });
    const barge = new Map(Object.entries({ length: 120, beam: 30, depth: 9, draught: 5.182 }).map(([k, si]) => [`vessel.${k}`, { given: true, si }]));
    // the displacement of a box in sea water, from which the files of BGL-1 were made
    expect(motionValue('coupled', 'data/bgl1/bgl1.hst', barge)).toMatchObject({ coupled: { hydrodynamics: 'data/bgl1/bgl1', mass: '19122 t', gyration: { roll: '10.5 m', pitch: '30 m', yaw: '30 m' } } });
    expect(motionValue('coupled', 'ship.nc', barge)).toMatchObject({ coupled: { hydrodynamics: 'ship.nc' } });
  });
  test('fields required by a sea state', () => {
    expect(askedOfWaves('jonswap')).toEqual(['hs', 'tp']);
    expect(askedOfWaves('airy')).toEqual(['height', 'period']);
    expect(askedOfWaves('none')).toEqual([]);
  });
});
