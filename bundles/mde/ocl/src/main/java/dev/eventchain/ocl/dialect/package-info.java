/**
 * Extension points of the language: dialects, libraries of operations, and the types that a library
 * chooses by. Knows no parser.
 */
package dev.eventchain.ocl.dialect;
