/**
 * Models and metamodels as diagrams, and a chain as the nodes and edges of a picture. Depends on no
 * project, run or report.
 */
package dev.eventchain.pipeline.diagram;
