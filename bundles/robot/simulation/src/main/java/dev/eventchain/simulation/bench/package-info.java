/**
 * The bench, which connects the topics of the software with the world: its reader, its checks and
 * the signals that formulas may name. Knows no scenario and no running node.
 */
package dev.eventchain.simulation.bench;
