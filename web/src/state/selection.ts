// The selected object of the model, or the default one.
import { computed } from '@preact/signals';
import { tree } from '../logic/formTree';
import { findNode, firstObject } from '../logic/modelTree';
import { fields } from './model';
import { object } from './workspace';

export const sections = computed(() => tree(fields.value));
export const shownObject = computed(() => (object.value && findNode(sections.value, object.value) ? object.value : firstObject(sections.value)));
