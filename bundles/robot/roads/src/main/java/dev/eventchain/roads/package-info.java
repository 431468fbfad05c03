/** Road networks of ASAM OpenDRIVE: geometry, lanes, links, positions and routes. */
package dev.eventchain.roads;
