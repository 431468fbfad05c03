/** Messages of a network with their signals, and what components see of them. */
package dev.eventchain.catalogue.network;
