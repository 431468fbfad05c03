/**
 * Compiled templates and queries: their steps, and the dispatch of calls. Independent of the syntax
 * tree, except for places and visibility.
 */
package dev.eventchain.m2t.template;
