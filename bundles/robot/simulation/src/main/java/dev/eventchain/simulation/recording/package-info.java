/**
 * Recordings of scenarios as MCAP files: the messages, and the poses of everything in the scene.
 * Knows no chain and does not drive.
 */
package dev.eventchain.simulation.recording;
