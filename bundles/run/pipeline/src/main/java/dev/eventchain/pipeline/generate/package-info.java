/**
 * Validation of the model and generation of the middleware package, with the trace of generated
 * lines. Depends on no language model, and does not run the generated code.
 */
package dev.eventchain.pipeline.generate;
