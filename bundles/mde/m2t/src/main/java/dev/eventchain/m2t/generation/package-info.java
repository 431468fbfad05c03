/**
 * Input and output of a generation besides the model: earlier files and properties, the generated
 * files, findings and their trace. Independent of templates.
 */
package dev.eventchain.m2t.generation;
