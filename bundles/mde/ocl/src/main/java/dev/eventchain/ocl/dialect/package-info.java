/**
 * Extension points of the language: dialects, libraries of operations, and their type system.
 * Independent of the parser.
 */
package dev.eventchain.ocl.dialect;
