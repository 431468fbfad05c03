/** The search for the smallest value of a function on the unit cube. */
package dev.eventchain.pipeline.search;
