/**
 * Findings of a run, with the calls and the model element they belong to. Knows no step or file.
 */
package dev.eventchain.m2t.report;
