/**
 * Questions about the syntax trees of Eclipse OCL: literals, positions in the source, and the
 * origin of an invalid value. Neither parses nor evaluates.
 */
package dev.eventchain.ocl.tree;
