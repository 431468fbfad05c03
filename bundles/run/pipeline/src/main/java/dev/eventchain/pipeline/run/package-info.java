/**
 * A run as its caller sees it: its stages, its options, its progress and its result. Knows nothing
 * of how the stages work.
 */
package dev.eventchain.pipeline.run;
