/**
 * A run as its caller sees it: its stages, options, progress and result. Does not depend on the
 * work of the stages.
 */
package dev.eventchain.pipeline.run;
