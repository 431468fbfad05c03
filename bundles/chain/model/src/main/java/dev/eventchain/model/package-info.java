/**
 * Event chains: metamodel, standard constraints, topics and data flow. Independent of project files
 * and of other formats.
 */
package dev.eventchain.model;
