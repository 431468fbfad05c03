/**
 * The simulation stage: the scenarios and faults of a project, the verdict, and the evidence for
 * each requirement. Does not know how the components were written, nor the page that shows the
 * results.
 */
package dev.eventchain.pipeline.simulate;
