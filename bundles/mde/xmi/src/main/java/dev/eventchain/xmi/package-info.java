/**
 * The XMI files of a project, for models of any Ecore metamodel: read strictly and as data, written
 * with the same bytes on every machine, and checked as EMF checks them.
 */
package dev.eventchain.xmi;
