/** Findings of a run, with their calls and model element. Independent of steps and files. */
package dev.eventchain.m2t.report;
