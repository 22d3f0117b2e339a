// Workbooks made by the page: archives that spreadsheets can open.
import { expect, test } from 'vitest';
import { columnLetters, crc32, makeSheet, workbookBytes } from '../src/components/workbook';

test('columns are named as in a spreadsheet', () => expect([0, 25, 26, 701, 702].map(columnLetters)).toEqual(['A', 'Z', 'AA', 'ZZ', 'AAA']));

test('the check sum is that of zip archives', () => expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926));

test('a workbook is a sound archive with its sheets, numbers as numbers and texts escaped', () => {
  const sheet = makeSheet({ title: 'A/B', look: '', columns: [{ title: 'depth', unit: 'm' }, { title: 'check', words: true }], rows: [[70.5, 'f < 1 & "x"'], [null, { verdict: 'passed', text: 'passes' }]] });
  const bytes = workbookBytes([sheet, sheet]), text = new TextDecoder().decode(bytes);
  const end = new DataView(bytes.buffer, bytes.length - 22), entries = end.getUint16(10, true), directory = end.getUint32(16, true);
  expect([end.getUint32(0, true), entries]).toEqual([0x06054b50, 7]);
  expect(new DataView(bytes.buffer).getUint32(directory, true)).toBe(0x02014b50);
  expect(text).toMatch(/name="A B" sheetId="1".*name="A B 2" sheetId="2"/);
  expect(text).toContain('<c r="A1" s="1" t="inlineStr"><is><t xml:space="preserve">depth [m]</t>');
  expect(text).toContain('<c r="A2"><v>70.5</v></c>');
  expect(text).toContain('f &lt; 1 &amp; &quot;x&quot;');
  expect(text).toContain('passes');
});
