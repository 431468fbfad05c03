/**
 * XMI files of a project, for models of any Ecore metamodel: strict reading as data, reproducible
 * writing, and the checks of EMF.
 */
package dev.eventchain.xmi;
