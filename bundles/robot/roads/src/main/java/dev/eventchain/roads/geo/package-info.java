/** Places on the earth in the plane of a map. */
package dev.eventchain.roads.geo;
