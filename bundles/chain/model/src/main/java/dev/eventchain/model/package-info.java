/**
 * Event chains: their metamodel, the constraints that hold for all of them, their topics and the
 * flow of data in them. It knows no file of a project and no format but its own.
 */
package dev.eventchain.model;
