/**
 * Runs nodes in a confined process in lock-step: the protocol, its checks, and the session that
 * every driver implements. Knows no world and no scenario.
 */
package dev.eventchain.simulation.host;
