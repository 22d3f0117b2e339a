// The object of the model that is shown as selected: the one chosen, else the first that matters.
import { computed } from '@preact/signals';
import { tree } from '../logic/formTree';
import { findNode, firstObject } from '../logic/modelTree';
import { fields } from './model';
import { object } from './workspace';

export const sections = computed(() => tree(fields.value));
export const shownObject = computed(() => (object.value && findNode(sections.value, object.value) ? object.value : firstObject(sections.value)));
