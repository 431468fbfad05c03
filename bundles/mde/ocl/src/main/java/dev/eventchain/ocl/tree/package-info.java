/**
 * Queries on the syntax trees of Eclipse OCL: literals, positions in the source, and the origin of
 * an invalid value. Independent of parsing and evaluation.
 */
package dev.eventchain.ocl.tree;
