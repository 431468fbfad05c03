/**
 * The files of a new project. Depends on neither language models nor simulation: its caller
 * provides the bench.
 */
package dev.eventchain.pipeline.start;
