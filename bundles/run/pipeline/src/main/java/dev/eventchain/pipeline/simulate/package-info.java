/**
 * The simulation stage: the scenarios and faults of a project, the verdict, and the evidence for
 * each requirement. Depends neither on the origin of the components nor on the report page.
 */
package dev.eventchain.pipeline.simulate;
