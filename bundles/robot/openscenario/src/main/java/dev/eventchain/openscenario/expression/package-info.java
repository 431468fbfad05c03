/** Expressions {@code ${...}} of OpenSCENARIO XML, section 9.2 of the standard's version 1.3. */
package dev.eventchain.openscenario.expression;
