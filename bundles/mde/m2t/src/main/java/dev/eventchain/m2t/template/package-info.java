/**
 * Compiled templates and queries: their steps, and the choice of the one that a call means. Knows
 * no syntax tree but for places and visibility.
 */
package dev.eventchain.m2t.template;
