/**
 * Models and metamodels as diagrams, and a chain as the nodes and edges of a picture. Knows no
 * project, no run and no report.
 */
package dev.eventchain.pipeline.diagram;
