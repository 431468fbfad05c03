/**
 * Validation of the model and generation of the package for the middleware, with the trace of
 * generated lines. Knows no language model and does not run what it generates.
 */
package dev.eventchain.pipeline.generate;
