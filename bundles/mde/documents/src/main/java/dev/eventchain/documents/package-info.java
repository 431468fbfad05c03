/** Strict readers of JSON and YAML files that keep the location of each value. */
package dev.eventchain.documents;
