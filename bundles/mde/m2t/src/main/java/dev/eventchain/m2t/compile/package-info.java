/**
 * The compiler of modules: links them, checks expressions, makes steps, and warns of doubtful
 * templates. Runs nothing.
 */
package dev.eventchain.m2t.compile;
