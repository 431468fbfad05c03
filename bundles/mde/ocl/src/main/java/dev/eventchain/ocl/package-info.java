/**
 * The language OCL over some metamodels: parsing, definitions, evaluation, and the reasons of false
 * and undefined values. The doors for other bundles; no type of Eclipse OCL leaves them.
 */
package dev.eventchain.ocl;
