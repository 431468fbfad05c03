/** Random values of parameters: distributions, and draws that are the same on each machine. */
package dev.eventchain.openscenario.distribution;
