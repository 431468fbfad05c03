/**
 * Scenarios as ASAM OpenSCENARIO XML 1.3 on ASAM OpenDRIVE 1.7 roads, for the players of those
 * formats.
 */
package dev.eventchain.simulation.export;
