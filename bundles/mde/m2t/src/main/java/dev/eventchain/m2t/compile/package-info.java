/**
 * Compiler of modules: linking, checks of expressions, creation of steps, and lint warnings. It
 * does not run templates.
 */
package dev.eventchain.m2t.compile;
