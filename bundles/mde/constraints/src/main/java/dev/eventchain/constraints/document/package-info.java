/**
 * Complete OCL documents as far as they can be read without their expressions: clauses, imports,
 * and the classes that contexts name.
 */
package dev.eventchain.constraints.document;
