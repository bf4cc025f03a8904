#!/bin/bash
# Solves jobs.jsonl, a job in each line, by 100 tasks of one core:
#
#     sbatch slurm_array.sh jobs.jsonl results
#
# Submitted again, it solves what is not there yet.
#SBATCH --array=1-100
#SBATCH --cpus-per-task=1
#SBATCH --mem=2G
#SBATCH --time=04:00:00
exec brinell solve --array "$1" --out "$2"
