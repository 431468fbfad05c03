/**
 * Files in OpenSCENARIO XML: what the standard lets stand where, parameters and expressions,
 * catalogs, and distributions of parameter values.
 */
package dev.eventchain.openscenario.document;
