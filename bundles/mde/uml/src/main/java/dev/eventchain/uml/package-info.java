/** The metamodel of UML, its libraries and profiles. Start with {@link dev.eventchain.uml.Uml}. */
package dev.eventchain.uml;
