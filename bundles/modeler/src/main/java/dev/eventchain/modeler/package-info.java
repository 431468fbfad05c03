/**
 * From JSON to models: event-chain descriptions, conceptual instance models of any Ecore metamodel,
 * and the files of a software base. Problems are findings with the JSON pointer, line and column.
 */
package dev.eventchain.modeler;
